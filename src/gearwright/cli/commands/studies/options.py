"""Options that the commands of studies share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

JournalArgument = Annotated[Path, typer.Argument(help="Journal that a study writes", metavar="JOURNAL")]
WorkersOption = Annotated[
    int | None, typer.Option(help="Processes that compute; 0: none beside this one; left out: as many as cores", min=0)
]
ShardOption = Annotated[
    str | None, typer.Option(help="Compute only this part, such as 2/8: for machines that know nothing of each other")
]
ClusterOption = Annotated[str | None, typer.Option(help="Address of a Dask scheduler, such as tcp://10.0.0.1:8786")]
TlsOption = Annotated[
    tuple[Path, Path, Path] | None,
    typer.Option(help="Encrypt and authenticate: files of authority, certificate and key (PEM)", metavar="CA CERT KEY"),
]
CsvOption = Annotated[Path | None, typer.Option(help="Write the table as CSV")]
ExportOption = Annotated[Path | None, typer.Option(help="Write the table for other programs (.nc or .parquet)")]
StudyReportOption = Annotated[Path | None, typer.Option("--report", help="Write one page that says what comes out")]
