"""What only sheets of gears have: the view along the axis, and edges.

What all drawings are made of lies in `sheet` and `views` beside this folder.
"""
