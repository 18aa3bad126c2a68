"""The EC120B "Colibri" term project computed number by number: what it assumes, what is wrong, what is right.

A client of the public verbs; nothing in the engine knows it.
"""

from gearwright.replays.replay import Replay, register

register(Replay("colibri", 'The transmission of the EC120B "Colibri" (term project)'))
