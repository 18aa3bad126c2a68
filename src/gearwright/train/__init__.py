"""The power train: its graph, speeds, torques and powers, and the ratios asked of its stages."""
