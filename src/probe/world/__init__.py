"""Physics: the only folder that knows MuJoCo's engine. No pictures, no questions."""
