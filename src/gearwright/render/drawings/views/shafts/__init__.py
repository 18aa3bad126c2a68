"""What a sheet of a shaft shows beside its outline: threads with their data."""
