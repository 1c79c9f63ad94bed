"""MuJoCo's viewer; only importing its modules matters here."""
