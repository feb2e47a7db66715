mod named;
