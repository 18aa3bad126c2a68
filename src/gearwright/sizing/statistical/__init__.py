"""What gearboxes weigh by statistics: public mass methods, the refit of real weights, their comparison."""
