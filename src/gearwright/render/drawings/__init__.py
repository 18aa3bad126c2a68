"""Technical drawings of a sizing: sheets of entities in mm of paper, and their writers."""
