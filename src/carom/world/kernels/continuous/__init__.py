"""The continuous step: times of impact, dealt with in their order."""
