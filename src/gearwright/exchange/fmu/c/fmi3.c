/* A drive train by FMI 3.0 for co-simulation; see README.txt. */

#include "model.h"

static void tell(Instance *instance, int status, const char *text) {
    if (instance->logger) instance->logger(instance->environment, (fmi3Status)status, "logStatusError", text);
}

EXPORT const char *FMI(fmi3GetVersion)(void) { return "3.0"; }

EXPORT fmi3Status FMI(fmi3SetDebugLogging)(fmi3Instance c, fmi3Boolean on, size_t n, const fmi3String categories[]) {
    (void)c, (void)on, (void)n, (void)categories;
    return fmi3OK;
}

EXPORT fmi3Instance FMI(fmi3InstantiateCoSimulation)(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean on, fmi3Boolean events,
    fmi3Boolean early, const fmi3ValueReference required[], size_t n, fmi3InstanceEnvironment environment,
    fmi3LogMessageCallback logger, fmi3IntermediateUpdateCallback update) {
    (void)resources, (void)visible, (void)on, (void)events, (void)early, (void)required, (void)update;
    if (!token || strcmp(token, TOKEN) != 0 || n) return NULL;
    return made(name, logger, environment);
}

EXPORT fmi3Instance FMI(fmi3InstantiateModelExchange)(fmi3String name, fmi3String token, fmi3String resources,
                                                      fmi3Boolean visible, fmi3Boolean on,
                                                      fmi3InstanceEnvironment environment,
                                                      fmi3LogMessageCallback logger) {
    (void)name, (void)token, (void)resources, (void)visible, (void)on, (void)environment, (void)logger;
    return NULL;
}

EXPORT fmi3Instance FMI(fmi3InstantiateScheduledExecution)(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean on,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger, fmi3ClockUpdateCallback update,
    fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock) {
    (void)name, (void)token, (void)resources, (void)visible, (void)on, (void)environment, (void)logger;
    (void)update, (void)lock, (void)unlock;
    return NULL;
}

EXPORT void FMI(fmi3FreeInstance)(fmi3Instance c) { freed(c); }

EXPORT fmi3Status FMI(fmi3EnterInitializationMode)(fmi3Instance c, fmi3Boolean tolerant, fmi3Float64 tolerance,
                                                   fmi3Float64 start, fmi3Boolean stops, fmi3Float64 stop) {
    (void)tolerant, (void)tolerance, (void)stops, (void)stop;
    if (!in_mode(c, MADE, MADE, "EnterInitializationMode")) return fmi3Error;
    if (!isfinite(start)) return (fmi3Status)refuse(c, "the start time is %g; it must be finite", start);
    begin_at(&((Instance *)c)->now, start);
    return (fmi3Status)enter_initialization(c);
}

EXPORT fmi3Status FMI(fmi3ExitInitializationMode)(fmi3Instance c) { return (fmi3Status)exit_initialization(c); }

EXPORT fmi3Status FMI(fmi3Terminate)(fmi3Instance c) { return (fmi3Status)terminate(c); }

EXPORT fmi3Status FMI(fmi3Reset)(fmi3Instance c) { return (fmi3Status)reset(c); }

EXPORT fmi3Status FMI(fmi3GetFloat64)(fmi3Instance c, const fmi3ValueReference r[], size_t n, fmi3Float64 x[],
                                      size_t values) {
    return values == n ? (fmi3Status)get_all(c, r, n, x) : fmi3Error;
}

EXPORT fmi3Status FMI(fmi3SetFloat64)(fmi3Instance c, const fmi3ValueReference r[], size_t n, const fmi3Float64 x[],
                                      size_t values) {
    return values == n ? (fmi3Status)set_all(c, r, n, x) : fmi3Error;
}

EXPORT fmi3Status FMI(fmi3GetBoolean)(fmi3Instance c, const fmi3ValueReference r[], size_t n, fmi3Boolean x[],
                                      size_t values) {
    if (values != n || !in_mode(c, MADE, TERMINATED, "GetBoolean")) return fmi3Error;
    for (size_t i = 0; i < n; i++) {
        const int *place = switch_of(c, r[i]);
        if (!place) return fmi3Error;
        x[i] = *place != 0;
    }
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3SetBoolean)(fmi3Instance c, const fmi3ValueReference r[], size_t n, const fmi3Boolean x[],
                                      size_t values) {
    if (values != n) return fmi3Error;
    for (size_t i = 0; i < n; i++)
        if (throw_switch(c, r[i], x[i])) return fmi3Error;
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3DoStep)(fmi3Instance c, fmi3Float64 time, fmi3Float64 length, fmi3Boolean stays,
                                  fmi3Boolean *event, fmi3Boolean *ends, fmi3Boolean *early, fmi3Float64 *reached) {
    fmi3Status status = (fmi3Status)do_step(c, time, length);
    (void)stays;
    *event = *ends = *early = false;
    if (c) *reached = ((Instance *)c)->now.time;
    return status;
}

EXPORT fmi3Status FMI(fmi3GetFMUState)(fmi3Instance c, fmi3FMUState *s) { return (fmi3Status)save_state(c, s); }

EXPORT fmi3Status FMI(fmi3SetFMUState)(fmi3Instance c, fmi3FMUState s) { return (fmi3Status)restore_state(c, s); }

EXPORT fmi3Status FMI(fmi3FreeFMUState)(fmi3Instance c, fmi3FMUState *s) {
    (void)c;
    return (fmi3Status)free_state(s);
}

EXPORT fmi3Status FMI(fmi3SerializedFMUStateSize)(fmi3Instance c, fmi3FMUState s, size_t *size) {
    (void)c, (void)s;
    *size = sizeof(Motion);
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3SerializeFMUState)(fmi3Instance c, fmi3FMUState s, fmi3Byte bytes[], size_t size) {
    return (fmi3Status)state_to_bytes(c, s, bytes, size);
}

EXPORT fmi3Status FMI(fmi3DeserializeFMUState)(fmi3Instance c, const fmi3Byte bytes[], size_t size, fmi3FMUState *s) {
    return (fmi3Status)bytes_to_state(c, bytes, size, s);
}

/* What this model has none of: numbers of other types, clocks, events, derivatives, steps within steps. */

#define NO_VARIABLES(Type)                                                                                             \
    EXPORT fmi3Status FMI(fmi3Get##Type)(fmi3Instance c, const fmi3ValueReference r[], size_t n, fmi3##Type x[],       \
                                         size_t values) {                                                              \
        (void)c, (void)r, (void)x, (void)values;                                                                       \
        return n ? fmi3Error : fmi3OK;                                                                                 \
    }                                                                                                                  \
    EXPORT fmi3Status FMI(fmi3Set##Type)(fmi3Instance c, const fmi3ValueReference r[], size_t n, const fmi3##Type x[], \
                                         size_t values) {                                                              \
        (void)c, (void)r, (void)x, (void)values;                                                                       \
        return n ? fmi3Error : fmi3OK;                                                                                 \
    }

NO_VARIABLES(Float32)
NO_VARIABLES(Int8)
NO_VARIABLES(UInt8)
NO_VARIABLES(Int16)
NO_VARIABLES(UInt16)
NO_VARIABLES(Int32)
NO_VARIABLES(UInt32)
NO_VARIABLES(Int64)
NO_VARIABLES(UInt64)
NO_VARIABLES(String)

EXPORT fmi3Status FMI(fmi3GetBinary)(fmi3Instance c, const fmi3ValueReference r[], size_t n, size_t sizes[],
                                     fmi3Binary x[], size_t values) {
    (void)c, (void)r, (void)sizes, (void)x, (void)values;
    return n ? fmi3Error : fmi3OK;
}

EXPORT fmi3Status FMI(fmi3SetBinary)(fmi3Instance c, const fmi3ValueReference r[], size_t n, const size_t sizes[],
                                     const fmi3Binary x[], size_t values) {
    (void)c, (void)r, (void)sizes, (void)x, (void)values;
    return n ? fmi3Error : fmi3OK;
}

/* A function that is there because the standard lists it, and that refuses. */
#define REFUSED(name, ...) \
    EXPORT fmi3Status FMI(name)(__VA_ARGS__) { return fmi3Error; }

#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

REFUSED(fmi3GetClock, fmi3Instance c, const fmi3ValueReference r[], size_t n, fmi3Clock x[])
REFUSED(fmi3SetClock, fmi3Instance c, const fmi3ValueReference r[], size_t n, const fmi3Clock x[])
REFUSED(fmi3GetNumberOfVariableDependencies, fmi3Instance c, fmi3ValueReference r, size_t *n)
REFUSED(fmi3GetVariableDependencies, fmi3Instance c, fmi3ValueReference dependent, size_t elements[],
        fmi3ValueReference independents[], size_t others[], fmi3DependencyKind kinds[], size_t n)
REFUSED(fmi3GetDirectionalDerivative, fmi3Instance c, const fmi3ValueReference unknown[], size_t n,
        const fmi3ValueReference known[], size_t m, const fmi3Float64 seed[], size_t seeds, fmi3Float64 change[],
        size_t changes)
REFUSED(fmi3GetAdjointDerivative, fmi3Instance c, const fmi3ValueReference unknown[], size_t n,
        const fmi3ValueReference known[], size_t m, const fmi3Float64 seed[], size_t seeds, fmi3Float64 change[],
        size_t changes)
REFUSED(fmi3EnterConfigurationMode, fmi3Instance c)
REFUSED(fmi3ExitConfigurationMode, fmi3Instance c)
REFUSED(fmi3GetIntervalDecimal, fmi3Instance c, const fmi3ValueReference r[], size_t n, fmi3Float64 x[],
        fmi3IntervalQualifier kinds[])
REFUSED(fmi3GetIntervalFraction, fmi3Instance c, const fmi3ValueReference r[], size_t n, fmi3UInt64 counters[],
        fmi3UInt64 resolutions[], fmi3IntervalQualifier kinds[])
REFUSED(fmi3GetShiftDecimal, fmi3Instance c, const fmi3ValueReference r[], size_t n, fmi3Float64 x[])
REFUSED(fmi3GetShiftFraction, fmi3Instance c, const fmi3ValueReference r[], size_t n, fmi3UInt64 counters[],
        fmi3UInt64 resolutions[])
REFUSED(fmi3SetIntervalDecimal, fmi3Instance c, const fmi3ValueReference r[], size_t n, const fmi3Float64 x[])
REFUSED(fmi3SetIntervalFraction, fmi3Instance c, const fmi3ValueReference r[], size_t n, const fmi3UInt64 counters[],
        const fmi3UInt64 resolutions[])
REFUSED(fmi3SetShiftDecimal, fmi3Instance c, const fmi3ValueReference r[], size_t n, const fmi3Float64 x[])
REFUSED(fmi3SetShiftFraction, fmi3Instance c, const fmi3ValueReference r[], size_t n, const fmi3UInt64 counters[],
        const fmi3UInt64 resolutions[])
REFUSED(fmi3EvaluateDiscreteStates, fmi3Instance c)
REFUSED(fmi3UpdateDiscreteStates, fmi3Instance c, fmi3Boolean *again, fmi3Boolean *ends, fmi3Boolean *nominals,
        fmi3Boolean *values, fmi3Boolean *next, fmi3Float64 *time)
REFUSED(fmi3EnterEventMode, fmi3Instance c)
REFUSED(fmi3EnterStepMode, fmi3Instance c)
REFUSED(fmi3EnterContinuousTimeMode, fmi3Instance c)
REFUSED(fmi3CompletedIntegratorStep, fmi3Instance c, fmi3Boolean stays, fmi3Boolean *event, fmi3Boolean *ends)
REFUSED(fmi3SetTime, fmi3Instance c, fmi3Float64 time)
REFUSED(fmi3SetContinuousStates, fmi3Instance c, const fmi3Float64 x[], size_t n)
REFUSED(fmi3GetContinuousStateDerivatives, fmi3Instance c, fmi3Float64 x[], size_t n)
REFUSED(fmi3GetEventIndicators, fmi3Instance c, fmi3Float64 x[], size_t n)
REFUSED(fmi3GetContinuousStates, fmi3Instance c, fmi3Float64 x[], size_t n)
REFUSED(fmi3GetNominalsOfContinuousStates, fmi3Instance c, fmi3Float64 x[], size_t n)
REFUSED(fmi3GetNumberOfEventIndicators, fmi3Instance c, size_t *n)
REFUSED(fmi3GetNumberOfContinuousStates, fmi3Instance c, size_t *n)
REFUSED(fmi3GetOutputDerivatives, fmi3Instance c, const fmi3ValueReference r[], size_t n, const fmi3Int32 orders[],
        fmi3Float64 x[], size_t values)
REFUSED(fmi3ActivateModelPartition, fmi3Instance c, fmi3ValueReference clock, fmi3Float64 time)
