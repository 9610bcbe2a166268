"""The course around the robots: the report's ledger, figures, explorers and exercises."""
