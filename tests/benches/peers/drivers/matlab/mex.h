// As much of MATLAB's interface as the sources of the peers name, so that they compile without it.
// None of these functions is called.
#pragma once

#include <cstddef>

struct mxArray {};
enum mxComplexity { mxREAL, mxCOMPLEX };

inline void mexErrMsgIdAndTxt(const char *, const char *, ...) {}
inline bool mxIsDouble(const mxArray *) { return false; }
inline bool mxIsComplex(const mxArray *) { return false; }
inline size_t mxGetNumberOfElements(const mxArray *) { return 0; }
inline double *mxGetPr(const mxArray *) { return nullptr; }
inline double *mxGetPi(const mxArray *) { return nullptr; }
inline mxArray *mxCreateDoubleMatrix(size_t, size_t, mxComplexity) { return nullptr; }
