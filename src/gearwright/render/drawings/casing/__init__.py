"""What drawings show of a housing: where a section runs through it, and what it cuts of it."""
