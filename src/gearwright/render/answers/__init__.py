"""What commands answer to machines: a record each, made JSON and its schema by one walk.

A key is the name of the attribute in Python with its unit, as in design files: ``mass_kg``. The rooms here say what
belongs to an answer; `plain` writes it and `described` gives its schema. No command's JSON is written anywhere else.
"""
