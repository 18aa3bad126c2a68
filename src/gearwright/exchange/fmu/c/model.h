/* The model as one unit: its numbers, its laws, its motion, and what both versions of the interface do with them. */

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "numbers.h"

#if defined(_WIN32) || defined(__CYGWIN__)
#define EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define EXPORT __attribute__((visibility("default")))
#else
#define EXPORT
#endif

static const double PI = 3.14159265358979323846;

/* Lengths of arrays: C has none of length zero. */
#define ROOM(count) ((count) > 0 ? (count) : 1)
#define LINES ROOM(LINE_COUNT)
#define TONES ROOM(TONE_COUNT)
#define MACHINES ROOM(MACHINE_COUNT)
#define DRIVE_INPUTS ROOM(DRIVE_INPUT_COUNT)
#define REPORT_COUNT (3 * DRIVE_COUNT)
#define REPORTS ROOM(REPORT_COUNT)
#define STATE_COUNT (2 * COORDINATES + DRIVE_STATES)
#define STATES STATE_COUNT

/* Inputs: torque of each machine, its speed where that is given, what drives read, and the speed factor. */
#define TORQUE_INPUT 0
#define SPEED_INPUT MACHINE_COUNT
#define READ_INPUT (2 * MACHINE_COUNT)
#define FACTOR_AT (READ_INPUT + DRIVE_INPUT_COUNT)
#define INPUT_COUNT (FACTOR_AT + FACTOR_INPUT)
#define INPUTS ROOM(INPUT_COUNT)

#include "laws.h"

#include "equations.h"

#include "motion.h"

#if FMI_VERSION == 3
#include "fmi3.h"
#else
#include "fmi2.h"
#endif

#include "instance.h"
