"""What a sheet of a shaft shows beside its outline: lengths, what stands above it, keyways, threads, hard surfaces."""
