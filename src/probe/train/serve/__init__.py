"""A trained model behind OpenAI's protocol, where vLLM can't run."""
