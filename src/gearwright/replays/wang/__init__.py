"""The paper on load sharing in a face-gear split-torque transmission, its claims held against gearwright.

A client of the public verbs; nothing in the engine knows it.
"""
