"""Tables of a Sizing: cases, margins, gears with every factor, mounted shafts, materials, what the user gave.

Tables of how it moves and lives stand beside this folder, drawings of its numbers in `figures`.
"""
