"""Pictures and labels of a Scene, drawn in a worker process. No physics."""
