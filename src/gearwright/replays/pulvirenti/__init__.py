"""The thesis on turboprop gearboxes held against gearwright: its errata, claims, flights of chapter 4, and their page.

A client of the public verbs; nothing in the engine knows it.
"""

from gearwright.replays.replay import Replay, register

register(
    Replay(
        "pulvirenti", "Pulvirenti 2023, turboprop gearboxes for conventional and hybrid-electric propulsion (thesis)"
    )
)
