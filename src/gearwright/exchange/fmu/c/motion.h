/* Motion in time: steps of one length by the classical Runge-Kutta method, whatever the steps of the simulator.

   Steps are counted from an anchor, the start or where an input last changed. A communication point between two of them
   is reached by a shorter step that the next one does not start from, so that the motion does not depend on how often
   it is looked at. */

enum { MADE, INITIALIZING, STEPPING, TERMINATED, FAILED };

/* All that an instance remembers; free of pointers, so that a copy of it is its state. */
typedef struct {
    int mode;
    int settled;                    /* inputs have taken effect */
    int seen_now;                   /* `seen` is that of now */
    double time;                    /* communication point [s] */
    double anchor;                  /* time from which steps are counted [s] */
    double travel;                  /* integral of the speed factor up to there [s] */
    double factor;                  /* speed factor since then, where it is an input */
    long long steps;                /* whole steps since the anchor */
    double whole[STATES];           /* state after them */
    double state[STATES];           /* state now */
    double input[INPUTS];           /* see `variables.h` */
    int given[MACHINES];            /* machine -> its speed is given, not its torque */
    int follows;                    /* the speed factor is that of the train itself */
    Seen seen;
} Motion;

/* Speed factor, its rate, and the travel since time 0 or the anchor. */
static double clock_at(const Motion *m, double time, double *factor, double *slope) {
#if FACTOR_INPUT
    *factor = m->factor;
    *slope = 0.0;
    return m->travel + m->factor * (time - m->anchor);
#else
    int i = PROFILE_COUNT - 1;
    (void)m;
    while (i >= 0 && PROFILE_TIME[i] > time) i--;
    if (i < 0) {
        *factor = PROFILE[0];
        *slope = 0.0;
        return PROFILE[0] * time;
    }
    *slope = i + 1 < PROFILE_COUNT ? (PROFILE[i + 1] - PROFILE[i]) / (PROFILE_TIME[i + 1] - PROFILE_TIME[i]) : 0.0;
    *factor = PROFILE[i] + *slope * (time - PROFILE_TIME[i]);
    return PROFILE_TRAVEL[i] + 0.5 * (PROFILE[i] + *factor) * (time - PROFILE_TIME[i]);
#endif
}

static double factor_of(const Motion *m) {
    double factor, slope;
    clock_at(m, m->time, &factor, &slope);
    return factor;
}

/* Fill everything that the clock and the inputs decide. */
static void set_instant(const Motion *m, double time, Instant *now) {
    double cosine[TONES] = {0.0}, sine[TONES] = {0.0}, travel = clock_at(m, time, &now->factor, &now->slope);
    for (int k = 0; k < TONE_COUNT; k++) {
        cosine[k] = cos(TONE_RATE[k] * travel);
        sine[k] = sin(TONE_RATE[k] * travel);
    }
    for (int j = 0; j < LINE_COUNT; j++) {
        double variation, slope;
        sum(VARIATION_START, VARIATION_TONE, VARIATION_COSINE, VARIATION_SINE, j, cosine, sine, &variation, &slope);
        now->stiffness[j] = STIFFNESS[j] * (1.0 + variation);
        sum(ERROR_START, ERROR_TONE, ERROR_COSINE, ERROR_SINE, j, cosine, sine, &now->error[j], &slope);
        now->error_rate[j] = slope * now->factor;
    }
    for (int i = 0; i < COORDINATES; i++) now->load[i] = LOAD[i] - MASS[i] * SPEED[i] * now->slope;
    for (int i = 0; i < SCHEDULE_COUNT; i++)
        now->load[SCHEDULE_DOF[i]] += curve(SCHEDULE_TIME, SCHEDULE, SCHEDULE_START[i], SCHEDULE_START[i + 1], time);
    /* LOAD has the torques of the case; an input that differs from it adds the difference. */
    for (int i = 0; i < MACHINE_COUNT; i++)
        now->load[MACHINE_DOF[i]] += (m->given[i] ? 0.0 : m->input[TORQUE_INPUT + i]) - INPUT_START[TORQUE_INPUT + i];
    for (int i = 0; i < DRIVE_INPUT_COUNT; i++)
        now->drive_input[i] = curve(READ_TIME, READ, READ_START[i], READ_START[i + 1], time) +
                              (m->input[READ_INPUT + i] - INPUT_START[READ_INPUT + i]);
}

/* Give machines of given speed that speed. */
static void keep_speeds(const Motion *m, double factor, double *state) {
    for (int i = 0; i < MACHINE_COUNT; i++) {
        int body = MACHINE_DOF[i];
        if (m->given[i]) state[COORDINATES + body] = m->input[SPEED_INPUT + i] - SPEED[body] * factor;
    }
}

/* One step; `now` is filled for its start, and afterwards for its end. */
static void step(const Motion *m, double *state, double middle, double end, double h, Instant *now, Instant *later) {
    double a[STATES], b[STATES], c[STATES], d[STATES], z[STATES];
    Seen spare;
    rates(now, m->given, state, a, &spare);
    for (int i = 0; i < STATE_COUNT; i++) z[i] = state[i] + 0.5 * h * a[i];
    set_instant(m, middle, later);
    rates(later, m->given, z, b, &spare);
    for (int i = 0; i < STATE_COUNT; i++) z[i] = state[i] + 0.5 * h * b[i];
    rates(later, m->given, z, c, &spare);
    for (int i = 0; i < STATE_COUNT; i++) z[i] = state[i] + h * c[i];
    set_instant(m, end, now);
    rates(now, m->given, z, d, &spare);
    for (int i = 0; i < STATE_COUNT; i++) state[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
    keep_speeds(m, now->factor, state);
}

/* Let inputs take effect: count steps from here. Every speed stays but those that are given; before the first step the
   speed factor sets them all. */
static void settle(Motion *m) {
    double factor, slope, travel = clock_at(m, m->time, &factor, &slope);
    if (m->settled) return;
#if FACTOR_INPUT
    if (m->mode == STEPPING)
        for (int i = 0; i < COORDINATES; i++) m->state[COORDINATES + i] += SPEED[i] * (factor - m->input[FACTOR_AT]);
    factor = m->factor = m->input[FACTOR_AT];
#endif
    keep_speeds(m, factor, m->state);
    m->travel = travel;
    m->anchor = m->time;
    m->steps = 0;
    memcpy(m->whole, m->state, sizeof m->whole);
    m->settled = 1;
    m->seen_now = 0;
}

/* Let the speed factor, with which phases of teeth run, be that of the train: the part of its motion in which nothing
   twists, to which vibrations have no share. */
static void follow(Motion *m) {
#if FACTOR_INPUT
    double moving = 0.0, reference = 0.0;
    for (int i = 0; i < COORDINATES; i++) {
        moving += MASS[i] * SPEED[i] * (SPEED[i] * m->factor + m->state[COORDINATES + i]);
        reference += MASS[i] * SPEED[i] * SPEED[i];
    }
    if (!m->follows || !(reference > 0.0)) return;
    m->input[FACTOR_AT] = moving / reference;
    m->settled = 0;
#else
    (void)m;
#endif
}

/* Work out forces and torques of now. */
static void look(Motion *m) {
    Instant now;
    double rate[STATES];
    settle(m);
    if (m->seen_now) return;
    set_instant(m, m->time, &now);
    rates(&now, m->given, m->state, rate, &m->seen);
    m->seen_now = 1;
}

/* Move on to a time; tells whether all numbers are finite. */
static int advance(Motion *m, double time) {
    Instant now, later;
    double from;
    settle(m);
    follow(m);
    settle(m);
    set_instant(m, m->anchor + (double)m->steps * STEP, &now);
    while (m->anchor + (double)(m->steps + 1) * STEP <= time) {
        double count = (double)m->steps;
        step(m, m->whole, m->anchor + (count + 0.5) * STEP, m->anchor + (count + 1.0) * STEP, STEP, &now, &later);
        m->steps++;
    }
    memcpy(m->state, m->whole, sizeof m->state);
    from = m->anchor + (double)m->steps * STEP;
    if (time > from) step(m, m->state, from + 0.5 * (time - from), time, time - from, &now, &later);
    m->time = time;
    m->seen_now = 0;
    for (int i = 0; i < STATE_COUNT; i++)
        if (!isfinite(m->state[i])) return 0;
    return 1;
}

/* The state before anything happened. */
static void begin(Motion *m) {
    memset(m, 0, sizeof *m);
    memcpy(m->state, START, sizeof m->state);
    memcpy(m->input, INPUT_START, sizeof m->input);
#if FACTOR_INPUT
    m->factor = PROFILE[0];
#endif
}

/* Begin at another time than 0. */
static void begin_at(Motion *m, double time) {
    m->time = time;
    m->settled = m->seen_now = 0;
}
