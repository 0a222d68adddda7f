//! The exceptions of this package.

pyo3::create_exception!(
    eliminant,
    SolveError,
    pyo3::exceptions::PyArithmeticError,
    "The data of an instance are not finite, or degenerate."
);

pyo3::create_exception!(
    eliminant,
    ProblemError,
    pyo3::exceptions::PyValueError,
    "A problem, or its template, is at fault. The text is what the command `eliminant` prints."
);

pyo3::create_exception!(
    eliminant.cylinders,
    CylinderError,
    pyo3::exceptions::PyValueError,
    "A scene is at fault, or its lines determine no cylinder."
);
