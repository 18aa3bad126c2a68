"""What people read: tables, words, figures, pages, drawings. Nothing below draws, and nothing here computes.

=============  ==================================================================================
room           makes
=============  ==================================================================================
``style``      the look that everything drawn shares
``tables``     tables of records with unit, equation and source
``words``      sentences and tables for the terminal, JSON and CSV for machines
``figures``    drawings of numbers
``schematic``  the skeleton of a train, the power flow and the mode shapes on it
``pages``      self-contained HTML pages, from ``templates``
``live``       scripts that make figures of pages answer a pointer, with the copy of ``uplot``
``drawings``   sheets of gears, shafts and the arrangement to ISO conventions
``diagrams``   sketches of what the lengths and angles of a design file are measured from
=============  ==================================================================================
"""
