"""Commands of one design: files to begin with, everything on one screen, checks, drawings, files for other tools."""
