/* The right-hand side: bodies, lines, loads and drives.

   deflection   delta = d.q - e(phase)
   force        f = k(phase) g(delta) + c (d.q' - e' + s sigma),   g: identity, or a dead zone with backlash
   motion       M q'' + s G q' - s^2 C q + sum d f = Q(t, q', x) - M W s',   x' = h(t, q', x) of the drives

   q is measured from the rigid motion W tau, tau = integral of the speed factor s. The order of operations is that of
   the program that wrote this model, so that both agree to rounding: compile without contraction of products and sums. */

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

/* What the clock alone decides at one instant. */
typedef struct {
    double factor;                    /* speed factor s */
    double slope;                     /* its rate [1/s] */
    double stiffness[LINES];          /* k(phase) */
    double error[LINES];              /* e(phase) */
    double error_rate[LINES];         /* de/dt */
    double load[COORDINATES];         /* constant and scheduled loads, machines, inertia of the speed profile */
    double drive_input[DRIVE_INPUTS]; /* what drives read */
} Instant;

/* What is asked for beside the rates. */
typedef struct {
    double force[LINES];      /* of lines [N or N m] */
    double holding[MACHINES]; /* torque that a machine of given speed exerts [N m] */
    double report[REPORTS];   /* of drives: torque, speed, flag of each */
} Seen;

/* A curve that is piecewise linear, held before its first and after its last point. */
static double curve(const double *time, const double *value, int first, int past, double at) {
    int low = first, high = past - 1;
    if (at <= time[low]) return value[low];
    if (at >= time[high]) return value[high];
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (time[middle] <= at) low = middle;
        else high = middle;
    }
    return (value[high] - value[low]) / (time[high] - time[low]) * (at - time[low]) + value[low];
}

/* Fourier sum of a line and its slope over tau. */
static void sum(const int *start, const int *tone, const double *a, const double *b, int line, const double *cosine,
                const double *sine, double *value, double *slope) {
    *value = *slope = 0.0;
    for (int i = start[line]; i < start[line + 1]; i++) {
        int k = tone[i];
        *value += a[i] * cosine[k] + b[i] * sine[k];
        *slope += (b[i] * cosine[k] - a[i] * sine[k]) * TONE_RATE[k];
    }
}

/* Line forces; they are taken from `pull`. */
static void apply_lines(const Instant *now, const double *position, const double *velocity, double *pull,
                        double *force) {
    for (int j = 0; j < LINE_COUNT; j++) {
        double deflection = -now->error[j], rate = now->factor * SLIP[j] - now->error_rate[j];
        for (int i = LINE_START[j]; i < LINE_START[j + 1]; i++) {
            deflection += LINE_WEIGHT[i] * position[LINE_DOF[i]];
            rate += LINE_WEIGHT[i] * velocity[LINE_DOF[i]];
        }
        double contact = deflection > 0.0 ? deflection : 0.0;
        if (deflection < -BACKLASH[j]) contact = deflection + BACKLASH[j];
        force[j] = now->stiffness[j] * contact + DAMPING[j] * rate;
        for (int i = LINE_START[j]; i < LINE_START[j + 1]; i++) pull[LINE_DOF[i]] -= LINE_WEIGHT[i] * force[j];
    }
}

/* Gyroscopic and centripetal forces of frames that turn. */
static void apply_frames(const Instant *now, const double *position, const double *velocity, double *pull) {
    for (int i = 0; i < GYROSCOPIC_COUNT; i++)
        pull[GYROSCOPIC_ROW[i]] += -now->factor * GYROSCOPIC[i] * velocity[GYROSCOPIC_COLUMN[i]];
    for (int i = 0; i < CENTRIPETAL_COUNT; i++)
        pull[CENTRIPETAL_ROW[i]] += now->factor * now->factor * CENTRIPETAL[i] * position[CENTRIPETAL_COLUMN[i]];
}

/* Rates of the state (q, q', x); machines of given speed keep theirs, and what holds them is seen. */
static void rates(const Instant *now, const int *given, const double *state, double *rate, Seen *seen) {
    const double *position = state, *velocity = state + COORDINATES;
    double *pull = rate + COORDINATES;
    for (int i = 0; i < COORDINATES; i++) pull[i] = 0.0;
    apply_drives(now->drive_input, now->factor, velocity, state + 2 * COORDINATES, pull, rate + 2 * COORDINATES,
                 seen->report);
    for (int i = 0; i < COORDINATES; i++) {
        double total = SPEED[i] * now->factor + velocity[i];
        rate[i] = velocity[i];
        pull[i] = now->load[i] + pull[i] - LOAD_DAMPING[i] * velocity[i];
        pull[i] -= LOAD_QUADRATIC[i] * fabs(total) * total;
    }
    apply_lines(now, position, velocity, pull, seen->force);
    apply_frames(now, position, velocity, pull);
    for (int m = 0; m < MACHINE_COUNT; m++) {
        int body = MACHINE_DOF[m];
        if (!given[m]) continue;
        seen->holding[m] = -MASS[body] * SPEED[body] * now->slope - pull[body];
        pull[body] += seen->holding[m];
    }
    for (int i = 0; i < COORDINATES; i++) rate[COORDINATES + i] /= MASS[i];
}
