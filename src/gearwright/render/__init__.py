"""What people read: tables, words, figures, the report. Nothing else in gearwright draws.

========================  ==========================================================================
module                    makes
========================  ==========================================================================
``tables``, ``views``     tables of records with unit, equation and source; those of a Sizing
``text``                  words for the terminal, JSON for machines
``schematic``             the skeleton of a train and the power flow on it
``figures_sizing``        masses, margins, shaft diagrams
``figures_motion``        forces against time, spectra, mode shapes
``report``                one self-contained HTML page
``theme``                 the look that all figures share
========================  ==========================================================================
"""
