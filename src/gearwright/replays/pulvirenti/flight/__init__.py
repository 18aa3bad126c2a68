"""Chapter 4 of the thesis flown again: its claims, how they are measured, what phasing does, their page and figures."""
