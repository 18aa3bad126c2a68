"""The air around the aircraft: standard atmosphere and airspeeds."""
