/* What both versions of the interface do: an instance, its variables, its steps.

   A variable's reference is a block and a number in it. */

enum { CLOCK, INPUT, SPEED_OF, FORCE_OF, TORQUE_OF, DRIVE_OF, GIVEN };
enum { OK, WARNING, DISCARD, ERROR };

/* The motion, and whom to tell what went wrong. */
typedef struct {
    Motion now;
    Logger logger;
    void *environment;
    char *name;
} Instance;

static void tell(Instance *instance, int status, const char *text); /* as the version of the interface has it */

static int refuse(Instance *instance, const char *form, ...) {
    char text[512];
    va_list rest;
    va_start(rest, form);
    vsnprintf(text, sizeof text, form, rest);
    va_end(rest);
    tell(instance, ERROR, text);
    return ERROR;
}

static Instance *made(const char *name, Logger logger, void *environment) {
    Instance *instance = malloc(sizeof *instance);
    size_t length = name ? strlen(name) : 0;
    if (!instance) return NULL;
    instance->name = malloc(length + 1);
    if (!instance->name) {
        free(instance);
        return NULL;
    }
    memcpy(instance->name, length ? name : "", length + 1);
    instance->logger = logger;
    instance->environment = environment;
    begin(&instance->now);
    return instance;
}

static void freed(Instance *instance) {
    if (!instance) return;
    free(instance->name);
    free(instance);
}

/* Refuse a call in a mode in which it may not come. */
static int in_mode(Instance *instance, int first, int last, const char *call) {
    static const char *const MODES[] = {"instantiated", "initialization mode", "step mode", "terminated", "failed"};
    if (!instance) return 0;
    if (first <= instance->now.mode && instance->now.mode <= last) return 1;
    refuse(instance, "%s may not be called in the state: %s", call, MODES[instance->now.mode]);
    return 0;
}

static int get(Instance *instance, unsigned reference, double *value) {
    Motion *now = &instance->now;
    unsigned block = reference >> 20;
    int number = (int)(reference & 0xfffff);
    look(now);
    if (block == CLOCK && number == 0) *value = now->time;
    else if (block == INPUT && number < INPUT_COUNT) *value = now->input[number];
    else if (block == SPEED_OF && number < COORDINATES)
        *value = SPEED[number] * factor_of(now) + now->state[COORDINATES + number];
    else if (block == FORCE_OF && number < LINE_COUNT) *value = now->seen.force[number];
    else if (block == TORQUE_OF && number < MACHINE_COUNT)
        *value = now->given[number] ? now->seen.holding[number] : now->input[TORQUE_INPUT + number];
    else if (block == DRIVE_OF && number < DRIVE_STATES) *value = now->state[2 * COORDINATES + number];
    else if (block == DRIVE_OF && number < DRIVE_STATES + REPORT_COUNT)
        *value = now->seen.report[number - DRIVE_STATES];
    else return refuse(instance, "there is no real variable with the reference %u", reference);
    return OK;
}

static int set(Instance *instance, unsigned reference, double value) {
    Motion *now = &instance->now;
    int number = (int)(reference & 0xfffff);
    if (reference >> 20 != INPUT || number >= INPUT_COUNT)
        return refuse(instance, "the reference %u is of no real input", reference);
    if (!isfinite(value)) return refuse(instance, "%s is to be %g; give a finite number", INPUT_NAME[number], value);
    if (now->input[number] == value) return OK;
    now->input[number] = value;
    now->settled = 0;
    return OK;
}

static int get_all(Instance *instance, const unsigned *references, size_t count, double *values) {
    if (!in_mode(instance, MADE, TERMINATED, "GetReal")) return ERROR;
    for (size_t i = 0; i < count; i++)
        if (get(instance, references[i], &values[i])) return ERROR;
    return OK;
}

static int set_all(Instance *instance, const unsigned *references, size_t count, const double *values) {
    if (!in_mode(instance, MADE, STEPPING, "SetReal")) return ERROR;
    for (size_t i = 0; i < count; i++)
        if (set(instance, references[i], values[i])) return ERROR;
    return OK;
}

/* Whether a machine's speed is given, and whether phases follow the train: the place of the answer, or nothing. */
static int *switch_of(Instance *instance, unsigned reference) {
    int number = (int)(reference & 0xfffff);
    if (reference >> 20 == GIVEN && number < MACHINE_COUNT) return &instance->now.given[number];
    if (reference >> 20 == GIVEN && number == MACHINE_COUNT && FACTOR_INPUT) return &instance->now.follows;
    refuse(instance, "there is no boolean variable with the reference %u", reference);
    return NULL;
}

static int throw_switch(Instance *instance, unsigned reference, int on) {
    int *place;
    if (!in_mode(instance, MADE, INITIALIZING, "SetBoolean") || !(place = switch_of(instance, reference))) return ERROR;
    *place = on;
    instance->now.settled = 0;
    return OK;
}

static int enter_initialization(Instance *instance) {
    if (!in_mode(instance, MADE, MADE, "EnterInitializationMode")) return ERROR;
    instance->now.mode = INITIALIZING;
    return OK;
}

static int exit_initialization(Instance *instance) {
    if (!in_mode(instance, INITIALIZING, INITIALIZING, "ExitInitializationMode")) return ERROR;
    for (int i = 0; i < MACHINE_COUNT; i++)
        for (int j = 0; j < i; j++)
            if (instance->now.given[i] && instance->now.given[j] && MACHINE_DOF[i] == MACHINE_DOF[j])
                return refuse(instance, "two machines of one body have their speeds given; give one of them a torque");
    settle(&instance->now);
    instance->now.mode = STEPPING;
    return OK;
}

static int terminate(Instance *instance) {
    if (!in_mode(instance, STEPPING, STEPPING, "Terminate")) return ERROR;
    instance->now.mode = TERMINATED;
    return OK;
}

static int reset(Instance *instance) {
    if (!instance) return ERROR;
    begin(&instance->now);
    return OK;
}

static int do_step(Instance *instance, double time, double length) {
    if (!in_mode(instance, STEPPING, STEPPING, "DoStep")) return ERROR;
    Motion *now = &instance->now;
    if (!isfinite(time) || !isfinite(length) || !(length > 0.0))
        return refuse(instance, "a step of %g s from %g s; its length must be positive and finite", length, time);
    if (fabs(time - now->time) > 1e-6 * length + 1e-12 * fabs(now->time))
        return refuse(instance, "a step from %.17g s, but the motion stands at %.17g s; restore a state to go back", time,
                      now->time);
    if (!(time + length > now->time)) return refuse(instance, "a step of %g s is lost in rounding", length);
    if (!advance(now, time + length)) {
        now->mode = FAILED;
        return refuse(instance, "the motion diverged before %.9g s; reset, or restore a state", now->time);
    }
    look(now);
    for (int i = 0; i < DRIVE_COUNT; i++)
        if (DRIVE_WARNS[i] && now->seen.report[3 * i + 2] != 0.0) {
            tell(instance, WARNING, "a propeller is outside its map: the edge of the map is taken");
            return WARNING;
        }
    return OK;
}

/* States of the instance: copies of its motion. */

static int save_state(Instance *instance, void **state) {
    if (!instance || !state) return ERROR;
    if (!*state) *state = malloc(sizeof(Motion));
    if (!*state) return refuse(instance, "there is no memory for a state");
    memcpy(*state, &instance->now, sizeof(Motion));
    return OK;
}

static int restore_state(Instance *instance, const void *state) {
    if (!instance || !state) return ERROR;
    memcpy(&instance->now, state, sizeof(Motion));
    return OK;
}

static int free_state(void **state) {
    if (!state) return OK;
    free(*state);
    *state = NULL;
    return OK;
}

static int state_to_bytes(Instance *instance, const void *state, void *bytes, size_t size) {
    if (!instance || !state || !bytes) return ERROR;
    if (size != sizeof(Motion)) return refuse(instance, "a state has %zu bytes, not %zu", sizeof(Motion), size);
    memcpy(bytes, state, size);
    return OK;
}

static int bytes_to_state(Instance *instance, const void *bytes, size_t size, void **state) {
    if (!instance || !bytes || !state) return ERROR;
    if (size != sizeof(Motion)) return refuse(instance, "a state has %zu bytes, not %zu", sizeof(Motion), size);
    if (!*state) *state = malloc(size);
    if (!*state) return refuse(instance, "there is no memory for a state");
    memcpy(*state, bytes, size);
    return OK;
}
