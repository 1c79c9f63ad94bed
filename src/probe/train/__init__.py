"""From a teacher's episodes to a smaller model: collect, choose, write down, tune, serve."""
