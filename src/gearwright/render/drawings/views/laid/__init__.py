"""Where shafts lie in the plane of a drawing."""
