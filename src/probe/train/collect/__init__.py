"""A teacher's episodes over fresh training tasks, batch by batch, until enough succeeded."""
