"""Data that comes with gearwright: materials, engines, gearbox weights; each with its provenance."""
