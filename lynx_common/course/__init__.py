"""The course around the robots: the report's ledger, figures, players, explorers, exercises, and their making."""
