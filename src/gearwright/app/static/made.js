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

/* A factor of which 1 is just enough: two digits behind the point, and never rounded up to 1. */
export function ratio(value) {
  if (value === null || value === undefined) return "–";
  const shown = value < 1 - 1e-9 ? Math.floor(value * 100) / 100 : value;
  return shown.toFixed(2);
}

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
