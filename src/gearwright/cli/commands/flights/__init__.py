"""Commands of what flies: missions, windows of them, lives, propellers, rotors, engines."""
