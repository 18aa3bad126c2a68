"""Closed-form machine elements: SI in, SI out, one idea a module, every formula with its source."""
