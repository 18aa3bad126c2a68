"""The thesis on turboprop gearboxes held against gearwright: its errata, claims, flights of chapter 4, and their page.

A client of the public verbs; nothing in the engine knows it.
"""
