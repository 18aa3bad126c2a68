"""The version: what results, pages and journals say they were made with."""

__version__ = "0.1.0"
