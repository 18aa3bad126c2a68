/* A drive train by FMI 2.0 for co-simulation; see README.txt. */

#include "model.h"

static void tell(Instance *instance, int status, const char *text) {
    if (instance->logger)
        instance->logger(instance->environment, instance->name, (fmi2Status)status, "logStatusError", text);
}

EXPORT const char *FMI(fmi2GetTypesPlatform)(void) { return "default"; }

EXPORT const char *FMI(fmi2GetVersion)(void) { return "2.0"; }

EXPORT fmi2Status FMI(fmi2SetDebugLogging)(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String categories[]) {
    (void)c, (void)on, (void)n, (void)categories;
    return fmi2OK;
}

EXPORT fmi2Component FMI(fmi2Instantiate)(fmi2String name, fmi2Type type, fmi2String token, fmi2String resources,
                                          const fmi2CallbackFunctions *functions, fmi2Boolean visible, fmi2Boolean on) {
    (void)resources, (void)visible, (void)on;
    if (type != fmi2CoSimulation || !token || strcmp(token, TOKEN) != 0) return NULL;
    return made(name, functions ? functions->logger : NULL, functions ? functions->componentEnvironment : NULL);
}

EXPORT void FMI(fmi2FreeInstance)(fmi2Component c) { freed(c); }

EXPORT fmi2Status FMI(fmi2SetupExperiment)(fmi2Component c, fmi2Boolean tolerant, fmi2Real tolerance, fmi2Real start,
                                           fmi2Boolean stops, fmi2Real stop) {
    (void)tolerant, (void)tolerance, (void)stops, (void)stop;
    if (!in_mode(c, MADE, MADE, "SetupExperiment")) return fmi2Error;
    if (!isfinite(start)) return (fmi2Status)refuse(c, "the start time is %g; it must be finite", start);
    begin_at(&((Instance *)c)->now, start);
    return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2EnterInitializationMode)(fmi2Component c) { return (fmi2Status)enter_initialization(c); }

EXPORT fmi2Status FMI(fmi2ExitInitializationMode)(fmi2Component c) { return (fmi2Status)exit_initialization(c); }

EXPORT fmi2Status FMI(fmi2Terminate)(fmi2Component c) { return (fmi2Status)terminate(c); }

EXPORT fmi2Status FMI(fmi2Reset)(fmi2Component c) { return (fmi2Status)reset(c); }

EXPORT fmi2Status FMI(fmi2GetReal)(fmi2Component c, const fmi2ValueReference r[], size_t n, fmi2Real x[]) {
    return (fmi2Status)get_all(c, r, n, x);
}

EXPORT fmi2Status FMI(fmi2SetReal)(fmi2Component c, const fmi2ValueReference r[], size_t n, const fmi2Real x[]) {
    return (fmi2Status)set_all(c, r, n, x);
}

EXPORT fmi2Status FMI(fmi2GetBoolean)(fmi2Component c, const fmi2ValueReference r[], size_t n, fmi2Boolean x[]) {
    if (!in_mode(c, MADE, TERMINATED, "GetBoolean")) return fmi2Error;
    for (size_t i = 0; i < n; i++) {
        const int *place = switch_of(c, r[i]);
        if (!place) return fmi2Error;
        x[i] = *place;
    }
    return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2SetBoolean)(fmi2Component c, const fmi2ValueReference r[], size_t n, const fmi2Boolean x[]) {
    for (size_t i = 0; i < n; i++)
        if (throw_switch(c, r[i], x[i] != 0)) return fmi2Error;
    return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2DoStep)(fmi2Component c, fmi2Real time, fmi2Real length, fmi2Boolean stays) {
    (void)stays;
    return (fmi2Status)do_step(c, time, length);
}

EXPORT fmi2Status FMI(fmi2GetFMUstate)(fmi2Component c, fmi2FMUstate *s) { return (fmi2Status)save_state(c, s); }

EXPORT fmi2Status FMI(fmi2SetFMUstate)(fmi2Component c, fmi2FMUstate s) { return (fmi2Status)restore_state(c, s); }

EXPORT fmi2Status FMI(fmi2FreeFMUstate)(fmi2Component c, fmi2FMUstate *s) {
    (void)c;
    return (fmi2Status)free_state(s);
}

EXPORT fmi2Status FMI(fmi2SerializedFMUstateSize)(fmi2Component c, fmi2FMUstate s, size_t *size) {
    (void)c, (void)s;
    *size = sizeof(Motion);
    return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2SerializeFMUstate)(fmi2Component c, fmi2FMUstate s, fmi2Byte bytes[], size_t size) {
    return (fmi2Status)state_to_bytes(c, s, bytes, size);
}

EXPORT fmi2Status FMI(fmi2DeSerializeFMUstate)(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *s) {
    return (fmi2Status)bytes_to_state(c, bytes, size, s);
}

EXPORT fmi2Status FMI(fmi2GetRealStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Real *value) {
    if (!c || kind != fmi2LastSuccessfulTime) return fmi2Discard;
    *value = ((Instance *)c)->now.time;
    return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2GetBooleanStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean *value) {
    if (!c || kind != fmi2Terminated) return fmi2Discard;
    *value = 0;
    return fmi2OK;
}

/* What this model has none of: whole numbers, texts, derivatives, steps that go on in the background. */

EXPORT fmi2Status FMI(fmi2GetInteger)(fmi2Component c, const fmi2ValueReference r[], size_t n, fmi2Integer x[]) {
    (void)c, (void)r, (void)x;
    return n ? fmi2Error : fmi2OK;
}

EXPORT fmi2Status FMI(fmi2SetInteger)(fmi2Component c, const fmi2ValueReference r[], size_t n, const fmi2Integer x[]) {
    (void)c, (void)r, (void)x;
    return n ? fmi2Error : fmi2OK;
}

EXPORT fmi2Status FMI(fmi2GetString)(fmi2Component c, const fmi2ValueReference r[], size_t n, fmi2String x[]) {
    (void)c, (void)r, (void)x;
    return n ? fmi2Error : fmi2OK;
}

EXPORT fmi2Status FMI(fmi2SetString)(fmi2Component c, const fmi2ValueReference r[], size_t n, const fmi2String x[]) {
    (void)c, (void)r, (void)x;
    return n ? fmi2Error : fmi2OK;
}

EXPORT fmi2Status FMI(fmi2GetDirectionalDerivative)(fmi2Component c, const fmi2ValueReference unknown[], size_t n,
                                                    const fmi2ValueReference known[], size_t m, const fmi2Real seed[],
                                                    fmi2Real change[]) {
    (void)c, (void)unknown, (void)n, (void)known, (void)m, (void)seed, (void)change;
    return fmi2Error;
}

EXPORT fmi2Status FMI(fmi2SetRealInputDerivatives)(fmi2Component c, const fmi2ValueReference r[], size_t n,
                                                   const fmi2Integer order[], const fmi2Real x[]) {
    (void)c, (void)r, (void)order, (void)x;
    return n ? fmi2Error : fmi2OK;
}

EXPORT fmi2Status FMI(fmi2GetRealOutputDerivatives)(fmi2Component c, const fmi2ValueReference r[], size_t n,
                                                    const fmi2Integer order[], fmi2Real x[]) {
    (void)c, (void)r, (void)order, (void)x;
    return n ? fmi2Error : fmi2OK;
}

EXPORT fmi2Status FMI(fmi2CancelStep)(fmi2Component c) {
    (void)c;
    return fmi2Error;
}

EXPORT fmi2Status FMI(fmi2GetStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Status *value) {
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}

EXPORT fmi2Status FMI(fmi2GetIntegerStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Integer *value) {
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}

EXPORT fmi2Status FMI(fmi2GetStringStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2String *value) {
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}
