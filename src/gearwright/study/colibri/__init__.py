"""The EC120B "Colibri" term project computed: every printed number, its mistakes on purpose, and what is right."""
