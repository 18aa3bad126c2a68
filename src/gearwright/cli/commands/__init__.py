"""The commands, a module for a kind of work: designs, runs, dynamics, load sharing, flights, studies, weights, replays.

What several of them share is in `cli` itself; what reaches a stream passes `terminal`.
"""
