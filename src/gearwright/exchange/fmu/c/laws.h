/* Laws of drives: a propeller by its map with its governor, a machine by its torque and its limits, a clutch that slips.

   DRIVE holds their records one after another, each with a head of eight numbers: length, kind, coordinate, its
   reference speed, second coordinate, its reference speed, first state, first input. */

#define HEAD 8
enum { PROPELLER, MACHINE, CLUTCH };

#if DRIVE_COUNT

static double within(double value, double low, double high) {
    return value < low ? low : (value > high ? high : value);
}

/* Cell of a rising grid in which a value lies, the nearest one outside. */
static int cell(const double *grid, int count, double value) {
    int low = 0, high = count - 1;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (grid[middle] < value) low = middle;
        else high = middle;
    }
    return low;
}

/* Power coefficient by bilinear interpolation; the flag is 1 outside the map. */
static double power_coefficient(const double *law, double ratio, double angle, double *flag) {
    const double slack = 1e-9; /* part of a cell by which rounding may leave the map */
    int rows = (int)law[9], columns = (int)law[10];
    const double *ratios = law + 11, *angles = ratios + rows, *power = angles + columns;
    const double *first = power + 2 * rows * columns, *last = first + rows;
    int i = cell(ratios, rows, ratio);
    int low = (int)(first[i] > first[i + 1] ? first[i] : first[i + 1]);
    int high = (int)(last[i] < last[i + 1] ? last[i] : last[i + 1]);
    int k = cell(angles, columns, angle);
    if (k < low) k = low;
    if (k > high - 1) k = high - 1;
    double u = (ratio - ratios[i]) / (ratios[i + 1] - ratios[i]);
    double v = (angle - angles[k]) / (angles[k + 1] - angles[k]);
    *flag = -slack <= u && u <= 1.0 + slack && -slack <= v && v <= 1.0 + slack ? 0.0 : 1.0;
    u = within(u, 0.0, 1.0);
    v = within(v, 0.0, 1.0);
    const double *c = power + i * columns + k, *d = c + columns;
    return (1.0 - u) * ((1.0 - v) * c[0] + v * c[1]) + u * ((1.0 - v) * d[0] + v * d[1]);
}

/* Rates of pitch, pitch rate and sum of speed errors: an actuator of first or second order between two stops. */
static void govern(const double *law, double error, double command, const double *state, double *rate) {
    double reference = law[1] + command, proportional = law[2], integral = law[3], time_constant = law[4];
    double damping = law[5], lower = law[6], upper = law[7], fastest = law[8];
    double asked = reference - proportional * error - integral * state[2];
    double gap = within(asked, lower, upper) - state[0];
    int stuck = (asked > upper && error < 0.0) || (asked < lower && error > 0.0);
    rate[2] = stuck ? 0.0 : error;
    if (damping == 0.0) {
        rate[0] = within(gap / time_constant, -fastest, fastest);
        rate[1] = 0.0;
        return;
    }
    double pull = (gap - 2.0 * damping * time_constant * state[1]) / (time_constant * time_constant);
    int at_limit = (state[1] >= fastest && pull > 0.0) || (state[1] <= -fastest && pull < 0.0);
    rate[0] = within(state[1], -fastest, fastest);
    rate[1] = at_limit ? 0.0 : pull;
}

/* Torque that a propeller takes [N m]; inputs: density, airspeed, set speed, pitch command. */
static double propeller(const double *law, const double *input, double speed, const double *state, double *rate,
                        double *flag) {
    double diameter = law[0], turns = fabs(speed) / (2.0 * PI);
    double power = power_coefficient(law, input[1] / (turns * diameter), state[0], flag);
    double torque = power * input[0] * turns * turns * pow(diameter, 5.0) / (2.0 * PI);
    govern(law, input[2] - fabs(speed), input[3], state, rate);
    return speed < 0.0 ? -torque : torque;
}

/* Torque of a machine on its shaft [N m]; input: torque at its reference speed. */
static double machine(const double *law, double command, double speed, double *flag) {
    double wanted = command * (1.0 + law[2] * (1.0 - law[0] * speed / law[1]));
    double by_power = law[4] / fabs(speed), limit = by_power < law[3] ? by_power : law[3];
    *flag = fabs(wanted) > limit ? 1.0 : 0.0;
    return law[0] * within(wanted, -limit, limit);
}

/* Torque of a clutch [N m], positive if the first rotation leads; input: torque at which it slips. */
static double clutch(const double *law, double capacity, double slip, const double *twist, double *rate,
                     double *flag) {
    double sticking = law[0] * twist[0] + law[1] * slip, torque = within(sticking, law[2] * capacity, capacity);
    *flag = torque == sticking ? 0.0 : 1.0;
    rate[0] = torque == sticking ? slip : (torque - law[0] * twist[0]) / law[1];
    return torque;
}
#endif

/* Add the torques of drives to `pull`, fill the rates of their states and what they report. */
static void apply_drives(const double *input, double factor, const double *velocity, const double *state, double *pull,
                         double *rate, double *report) {
#if DRIVE_COUNT
    const double *record = DRIVE;
    for (int n = 0; n < DRIVE_COUNT; n++, record += (int)record[0]) {
        const double *law = record + HEAD, *read = input + (int)record[7], *x = state + (int)record[6];
        int kind = (int)record[1], dof = (int)record[2], second = (int)record[4];
        double *moved = rate + (int)record[6], speed = record[3] * factor + velocity[dof], torque, flag;
        if (kind == PROPELLER) {
            torque = propeller(law, read, speed, x, moved, &flag);
            pull[dof] -= torque;
        } else if (kind == MACHINE) {
            torque = machine(law, read[0], speed, &flag);
            pull[dof] += torque;
        } else {
            speed -= record[5] * factor + velocity[second];
            torque = clutch(law, read[0], speed, x, moved, &flag);
            pull[dof] -= torque;
            pull[second] += torque;
        }
        report[3 * n] = torque;
        report[3 * n + 1] = speed;
        report[3 * n + 2] = flag;
    }
#else
    (void)input, (void)factor, (void)velocity, (void)state, (void)pull, (void)rate, (void)report;
#endif
}
