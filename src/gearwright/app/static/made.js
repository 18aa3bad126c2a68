/* Elements and numbers as text: nothing that comes from a design is ever read as markup. */
export const at = id => document.getElementById(id);

export function made(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name in element && name !== "list") element[name] = value;
    else element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

export function number(value, digits = 4) {
  if (value === null || value === undefined) return "–";
  if (typeof value !== "number") return String(value);
  if (value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e7)) return String(Number(value.toPrecision(digits)));
  return value.toExponential(digits - 1);
}

const NOISE = 1e-9; // of a margin, below which a difference is rounding [1]

/* A margin as reports and the command line have it: to the nearest, and what is below 1 never reads as 1. */
export function ratio(value, digits = 3) {
  if (value === null || value === undefined) return "–";
  if (value < 0) return `−${ratio(-value, digits)}`;
  if (value < NOISE) return "0";
  const exact = Number(value.toPrecision(12)); // a half is decided by these
  while (value < 1 - NOISE && Number(exact.toPrecision(digits)) >= 1) digits++;
  if (exact < 1e-3) return exact.toExponential(digits - 1).replace(/e-(\d)$/, "e-0$1");
  return exact >= 10 ** (digits - 1) ? exact.toFixed(0) : exact.toPrecision(digits);
}

/* A result by its name: margins as margins. */
export const told = (name, value) => (typeof value === "number" && /margin/.test(name) ? ratio(value, 4) : number(value));

const UNITS = {
  kg: "kg", mm: "mm", m: "m", l: "l", kw: "kW", w: "W", nm: "N m", knm: "kN m", n: "N", kn: "kN", mpa: "MPa", rpm: "rpm", deg: "°", um: "µm", h: "h", hz: "Hz",
  percent: "%", s: "s", m_s: "m/s", kg_m2: "kg m²", kw_kg: "kW/kg", knm_rad: "kN m/rad", rad_s: "rad/s", mrad: "mrad", degc: "°C",
};

/* "face_width_mm" as words and unit: the longest end of it that is a unit. */
export function named(key) {
  const parts = key.split("_");
  for (let k = 1; k < parts.length; k++) {
    const unit = UNITS[parts.slice(k).join("_")];
    if (unit) return [parts.slice(0, k).join(" "), unit];
  }
  return [parts.join(" "), ""];
}

export function change(now, then) {
  if (typeof now !== "number" || typeof then !== "number" || then === 0) return null;
  const share = (now - then) / Math.abs(then);
  return Math.abs(share) < 5e-7 ? 0 : share;
}

export function percent(share) {
  if (share === null) return "";
  if (share === 0) return "=";
  const sign = share > 0 ? "+" : "−", size = Math.abs(share) * 100;
  return `${sign}${size < 0.1 ? size.toPrecision(1) : size.toFixed(1)} %`;
}
