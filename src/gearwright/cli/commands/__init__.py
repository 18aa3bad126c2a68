"""The commands: `designs`, `flights`, `studies`, and here what shakes a train, load sharing, weights and replays.

What several of them share is in `cli` itself; what reaches a stream passes `terminal`.
"""
