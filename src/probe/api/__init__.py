"""What `import probe` offers: each module holds a few of its names. Prints nothing."""
