"""Which of a teacher's episodes to learn from: right, efficient, of no evaluation."""
