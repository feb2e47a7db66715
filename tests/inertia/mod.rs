mod moments;
mod principal;
mod tensor;
