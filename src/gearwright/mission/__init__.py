"""A mission flown by a sized gearbox: Mission x Sizing becomes a Flight."""
