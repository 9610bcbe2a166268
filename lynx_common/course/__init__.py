"""The course around the robots: the report's ledger, figures, stages, explorers, exercises, and their making."""
