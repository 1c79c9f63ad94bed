"""Where units of work are done: in processes of this machine, or on the nodes of a cluster."""
