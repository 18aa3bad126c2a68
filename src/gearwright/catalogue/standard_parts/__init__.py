"""Parts and fits that standards list: keys, nuts, rings, undercuts, centre holes, fits of seats and of gears.

Rolling bearings and materials are beside this folder; what parts bear is computed in `parts/joints`.
"""
