"""Makes tasks and proves them: candidates, their checks, and (later) that agents solve them."""
