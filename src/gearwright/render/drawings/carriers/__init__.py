"""Sheets of carriers: section through a pin, end view, how true pins stand.

What all drawings are made of lies in `sheet` and `views` beside this folder.
"""
