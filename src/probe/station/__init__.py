"""One arm, one camera, one table: what a skill may ask and do. No engine types."""
