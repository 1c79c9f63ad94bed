"""Downloads of public objects: where they lie, how they come, how they are unpacked."""
