"""From a teacher's episodes to examples for a smaller model: collect, select, write down."""
