"""gearwright designs aircraft transmissions and shows how they behave."""

__version__ = "0.1.0"
