"""Standard output and standard error: what they can show, words and tables on them, progress, the list of `--help`.

It knows no command, no design and no result; what is said is made by `render`.
"""
