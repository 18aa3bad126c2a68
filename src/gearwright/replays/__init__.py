"""Replays of published work: each holds a document against what gearwright computes.

Clients of the public verbs; no layer below knows them.
"""
