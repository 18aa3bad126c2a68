"""Flights in words and as CSV: phases, forces, dynamic windows, lives of several missions.

Which missions are flown is words of studies; how a flight is drawn is `figures` and `pages`.
"""
